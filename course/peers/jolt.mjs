// Jolt's CharacterVirtual on the movement course, moved by ExtendedUpdate as its own CharacterVirtual sample does: the
// slope limit, the step, the padding and the floor that it sticks to are the scene's; everything else is Jolt's default,
// with that sample's supporting volume and its rule against sliding down slopes that can be stood on.
import initialise from 'jolt-physics';
import { speak } from './protocol.mjs';

const Jolt = await initialise();
// `node jolt.mjs edges` has Jolt remove the inner edges of meshes, an option that is off by default.
const removes_edges = process.argv[2] === 'edges';
const standing = 0, moving = 1;  // object layers, and those of the broad phase
// What is made for one call is given back after it: WebAssembly's memory knows no garbage collection.
let made = [];
const brief = (object) => { made.push(object); return object; };
const give_back = () => { made.forEach((object) => Jolt.destroy(object)); made = []; };
const at = (v) => brief(new Jolt.RVec3(v.x, v.y, v.z));
const along = (x, y, z) => brief(new Jolt.Vec3(x, y, z));
const turned = (q) => brief(new Jolt.Quat(q.x, q.y, q.z, q.w));

function make_system() {
    const settings = new Jolt.JoltSettings();
    settings.mMaxWorkerThreads = 1;
    const pairs = new Jolt.ObjectLayerPairFilterTable(2);
    pairs.EnableCollision(standing, moving);
    const layers = new Jolt.BroadPhaseLayerInterfaceTable(2, 2);
    layers.MapObjectToBroadPhaseLayer(standing, new Jolt.BroadPhaseLayer(0));
    layers.MapObjectToBroadPhaseLayer(moving, new Jolt.BroadPhaseLayer(1));
    settings.mObjectLayerPairFilter = pairs;
    settings.mBroadPhaseLayerInterface = layers;
    settings.mObjectVsBroadPhaseLayerFilter = new Jolt.ObjectVsBroadPhaseLayerFilterTable(layers, 2, pairs, 2);
    const system = new Jolt.JoltInterface(settings);
    Jolt.destroy(settings);
    return system;
}

class Walker {
    constructor() {
        this.jolt = make_system();
        this.system = this.jolt.GetPhysicsSystem();
        this.interface = this.system.GetBodyInterface();
        this.bodies = new Map();
        this.filters = [
            new Jolt.DefaultBroadPhaseLayerFilter(this.jolt.GetObjectVsBroadPhaseLayerFilter(), moving),
            new Jolt.DefaultObjectLayerFilter(this.jolt.GetObjectLayerPairFilter(), moving),
            new Jolt.BodyFilter(),
            new Jolt.ShapeFilter(),
        ];
        this.listener = this.make_listener();
    }

    make_listener() {
        const listener = new Jolt.CharacterContactListenerJS();
        const nothing = () => {};
        for (const name of ['OnAdjustBodyVelocity', 'OnContactAdded', 'OnContactPersisted', 'OnContactRemoved',
            'OnCharacterContactAdded', 'OnCharacterContactPersisted', 'OnCharacterContactRemoved', 'OnCharacterContactSolve'])
            listener[name] = nothing;
        listener.OnContactValidate = () => true;
        listener.OnCharacterContactValidate = () => true;
        listener.OnContactSolve = (character, body, shape, position, normal, contact, material, velocity, result) => {
            const up = Jolt.wrapPointer(normal, Jolt.Vec3);
            const speed = Jolt.wrapPointer(contact, Jolt.Vec3);
            if (!this.wants_to_move && speed.Length() < 1e-6 && !this.character.IsSlopeTooSteep(up))
                Jolt.wrapPointer(result, Jolt.Vec3).Set(0, 0, 0);
        };
        return listener;
    }

    load({ settings, bodies, start }) {
        for (const body of this.bodies.values()) {
            this.interface.RemoveBody(body);
            this.interface.DestroyBody(body);
        }
        this.bodies.clear();
        for (const body of bodies) this.add(body);
        this.settings = settings;
        if (this.character) Jolt.destroy(this.character);
        const described = new Jolt.CharacterVirtualSettings();
        described.mMaxSlopeAngle = (settings.slope_limit_deg * Math.PI) / 180;
        // Jolt's lengths are for a person: the padding is the scene's skin, the others go with the radius.
        const size = settings.radius / 0.4;
        described.mCharacterPadding = settings.skin;
        described.mPredictiveContactDistance *= size;
        described.mCollisionTolerance *= size;
        described.mShape = new Jolt.CapsuleShape(settings.half_height, settings.radius);
        described.mEnhancedInternalEdgeRemoval = removes_edges;
        described.mSupportingVolume = brief(new Jolt.Plane(along(0, 1, 0), settings.half_height));
        this.character = new Jolt.CharacterVirtual(described, at(start), Jolt.Quat.prototype.sIdentity(), this.system);
        this.character.SetListener(this.listener);
        this.update ??= new Jolt.ExtendedUpdateSettings();
        this.update.mStickToFloorStepDown = along(0, -settings.snap_down, 0);
        this.update.mWalkStairsStepForwardTest = settings.step_depth;
        this.update.mWalkStairsMinStepForward = 0.02 * size;
        this.update.mWalkStairsStepUp = along(0, settings.step_up, 0);
        this.jump_held = false;
        give_back();
    }

    add({ number, vertices, indices, pose, moves }) {
        const corners = new Jolt.VertexList();
        for (let i = 0; i < vertices.length; i += 3)
            corners.push_back(brief(new Jolt.Float3(vertices[i], vertices[i + 1], vertices[i + 2])));
        const triangles = new Jolt.IndexedTriangleList();
        for (let i = 0; i < indices.length; i += 3)
            triangles.push_back(brief(new Jolt.IndexedTriangle(indices[i], indices[i + 1], indices[i + 2], 0)));
        const mesh = new Jolt.MeshShapeSettings(corners, triangles, brief(new Jolt.PhysicsMaterialList()));
        mesh.Sanitize();
        const shape = mesh.Create();
        if (shape.HasError()) throw new Error(shape.GetError().c_str());
        const described = new Jolt.BodyCreationSettings(
            shape.Get(), at(pose.position), turned(pose.rotation),
            moves ? Jolt.EMotionType_Kinematic : Jolt.EMotionType_Static, standing);
        const body = this.interface.CreateBody(described);
        this.interface.AddBody(body.GetID(), Jolt.EActivation_Activate);
        this.bodies.set(number, body.GetID());
        for (const object of [described, mesh, corners, triangles]) Jolt.destroy(object);
        give_back();
    }

    tick({ dt, wish, jump, poses }) {
        const { gravity, jump_height } = this.settings;
        for (const [number, pose] of poses)
            this.interface.MoveKinematic(this.bodies.get(number), at(pose.position), turned(pose.rotation), dt);
        this.wants_to_move = wish.x !== 0 || wish.z !== 0;
        const character = this.character;
        character.UpdateGroundVelocity();
        const ground = character.GetGroundVelocity();
        let vertical = character.GetLinearVelocity().GetY();
        const pressed = jump && !this.jump_held;
        this.jump_held = jump;
        const velocity = { x: wish.x, y: vertical, z: wish.z };
        if (character.GetGroundState() === Jolt.EGroundState_OnGround && vertical - ground.GetY() < 0.1) {
            velocity.x += ground.GetX();
            velocity.y = ground.GetY();
            velocity.z += ground.GetZ();
            if (pressed) velocity.y += Math.sqrt(2 * gravity * jump_height);
        }
        velocity.y -= gravity * dt;
        character.SetLinearVelocity(along(velocity.x, velocity.y, velocity.z));
        character.ExtendedUpdate(
            dt, along(0, -gravity, 0), this.update, ...this.filters, this.jolt.GetTempAllocator());
        // As in the sample, the world's own step comes after the character's.
        this.jolt.Step(dt, 1);
        give_back();
        const place = character.GetPosition();
        return {
            x: place.GetX(), y: place.GetY(), z: place.GetZ(),
            grounded: character.GetGroundState() === Jolt.EGroundState_OnGround,
        };
    }
}

await speak(new Walker());
